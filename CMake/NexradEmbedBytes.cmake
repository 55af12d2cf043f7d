# Writes the source of nexrad_embed: cmake -DINPUT=<file> -DSYMBOL=<symbol> -DOUTPUT=<source> -P NexradEmbedBytes.cmake
file(SIZE "${INPUT}" size)
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [=[
#include <cstddef>

namespace nexrad::embedded
{

extern const unsigned char @SYMBOL@[];
extern const std::size_t @SYMBOL@Size;
const unsigned char @SYMBOL@[] = {@bytes@};
const std::size_t @SYMBOL@Size = @size@;

} // namespace nexrad::embedded
]=])
