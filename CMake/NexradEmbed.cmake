# nexrad_embed(<target> <file> <symbol>)
#
# Compiles the bytes of <file> into <target>. C++ code sees them as
#   namespace nexrad::embedded { extern const unsigned char <symbol>[]; extern const std::size_t <symbol>Size; }
# The assembler copies the bytes (.incbin), so the size of the file does not matter to the compiler.
enable_language(ASM)
function(nexrad_embed target file symbol)
  get_filename_component(path "${file}" ABSOLUTE)
  string(LENGTH "${symbol}" length)
  string(LENGTH "${symbol}Size" lengthSize)
  # Itanium names of nexrad::embedded::<symbol> and <symbol>Size.
  set(mangled "_ZN6nexrad8embedded${length}${symbol}E")
  set(mangledSize "_ZN6nexrad8embedded${lengthSize}${symbol}SizeE")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${symbol}.s")
  file(CONFIGURE OUTPUT "${source}" CONTENT [=[
  .section .rodata
  .global @mangled@
  .type @mangled@, @object
  .balign 16
@mangled@:
  .incbin "@path@"
0:
  .size @mangled@, 0b - @mangled@
  .global @mangledSize@
  .type @mangledSize@, @object
  .balign 8
@mangledSize@:
  .quad 0b - @mangled@
  .size @mangledSize@, 8
  .section .note.GNU-stack,"",@progbits
]=] @ONLY)
  set_source_files_properties("${source}" PROPERTIES OBJECT_DEPENDS "${path}")
  target_sources(${target} PRIVATE "${source}")
endfunction()
