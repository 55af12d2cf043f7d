// SPDX-License-Identifier: BSD-3-Clause
#include "Output/PrintableOutput.h"

#include <cstdio>
#include <streambuf>

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
    // U+0080 to U+009F are control characters too; in UTF-8 their first byte is 0xC2.
    const bool control = (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') ||
                         byte == 0x7F || (before == 0xC2 && byte >= 0x80 && byte < 0xA0);
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
    char code[5];
    const int length = std::snprintf(code, sizeof code, "\\x%02x", byte);
    return target->sputn(code, length) == length;
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
