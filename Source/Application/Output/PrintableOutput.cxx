// SPDX-License-Identifier: BSD-3-Clause
#include "Output/PrintableOutput.h"

#include "nexrad/System/MessageText.h"

#include <streambuf>
#include <string>

namespace nexrad::application
{
namespace
{

class PrintableBuffer : public std::streambuf
{
public:
  explicit PrintableBuffer(std::streambuf* theTarget)
    : target(theTarget)
  {
  }

protected:
  int_type overflow(int_type value) override
  {
    if (traits_type::eq_int_type(value, traits_type::eof()))
    {
      return traits_type::not_eof(value);
    }
    const auto byte = static_cast<unsigned char>(traits_type::to_char_type(value));
    const bool layout = byte == '\n' || byte == '\r' || byte == '\t';
    const bool control = !layout && IsControlByte(byte, before);
    before = byte;
    return (control ? this->PutCode(byte) : this->PutByte(byte)) ? value : traits_type::eof();
  }

  int sync() override { return target->pubsync(); }

private:
  bool PutByte(unsigned char byte)
  {
    const int_type put = target->sputc(static_cast<char>(byte));
    return !traits_type::eq_int_type(put, traits_type::eof());
  }

  bool PutCode(unsigned char byte)
  {
    const std::string code = ControlText(byte);
    const auto length = static_cast<std::streamsize>(code.size());
    return target->sputn(code.data(), length) == length;
  }

  std::streambuf* const target;
  unsigned char before = 0;
};

} // namespace

PrintableOutput::PrintableOutput(std::ostream& theStream)
  : stream(theStream)
  , before(theStream.rdbuf())
  , filter(std::make_unique<PrintableBuffer>(before))
{
  stream.rdbuf(filter.get());
}

PrintableOutput::~PrintableOutput()
{
  stream.flush();
  stream.rdbuf(before);
}

} // namespace nexrad::application
