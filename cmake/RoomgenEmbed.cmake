# Files compiled into the library, as bytes that are used in place. An assembler includes them at once,
# where a compiler needs a second for 100 KB of numbers; without such an assembler they are numbers.
#
# roomgen_embed_bytes(<target> SYMBOL FILE …): pairs of a symbol and a file that may be made by the build.
#   extern "C" const unsigned char symbol[];
#   extern "C" const std::uint64_t symbol_size;
#
# roomgen_embed(<target> BASE <dir> FILES …): a table of files by their path below BASE (base/resource.h).
include_guard()

include(CMakeDependentOption)
cmake_dependent_option(ROOMGEN_INCBIN "Embed files with the assembler" ON "NOT MSVC" OFF)
if(ROOMGEN_INCBIN)
  enable_language(ASM)
endif()

function(roomgen_embed_bytes target)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/embedded")
  set(includes "")
  set(files "")
  set(pairs ${ARGN})
  while(pairs)
    list(POP_FRONT pairs symbol file)
    list(APPEND files "${file}")
    string(APPEND includes "EMBED(${symbol}, \"${file}\")\n")
    if(NOT ROOMGEN_INCBIN)
      add_custom_command(
        OUTPUT "${folder}/${symbol}.cpp"
        COMMAND ${CMAKE_COMMAND} "-DFILE=${file}" "-DSYMBOL=${symbol}"
                "-DOUTPUT=${folder}/${symbol}.cpp" -P
                "${PROJECT_SOURCE_DIR}/cmake/embed_numbers.cmake"
        DEPENDS "${file}" "${PROJECT_SOURCE_DIR}/cmake/embed_numbers.cmake"
        VERBATIM)
      set_source_files_properties("${folder}/${symbol}.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      target_sources(${target} PRIVATE "${folder}/${symbol}.cpp")
    endif()
  endwhile()
  if(ROOMGEN_INCBIN)
    configure_file("${PROJECT_SOURCE_DIR}/cmake/embed.S.in" "${folder}/${target}.S" @ONLY)
    set_source_files_properties("${folder}/${target}.S" PROPERTIES OBJECT_DEPENDS "${files}")
    target_sources(${target} PRIVATE "${folder}/${target}.S")
  endif()
endfunction()

function(roomgen_embed target)
  cmake_parse_arguments(arg "" "BASE" "FILES" ${ARGN})
  set(declarations "")
  set(entries "")
  set(pairs "")
  foreach(file IN LISTS arg_FILES)
    file(RELATIVE_PATH name "${arg_BASE}" "${file}")
    string(MAKE_C_IDENTIFIER "roomgen_${name}" symbol)
    list(APPEND pairs "${symbol}" "${file}")
    string(APPEND declarations
           "extern const unsigned char ${symbol}[];\nextern const std::uint64_t ${symbol}_size;\n")
    string(APPEND entries "  {\"${name}\", ${symbol}, &${symbol}_size},\n")
  endforeach()
  set(table "${CMAKE_CURRENT_BINARY_DIR}/${target}_resources.cpp")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/resource_table.cpp.in" "${table}" @ONLY)
  set_source_files_properties("${table}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE "${table}")
  roomgen_embed_bytes(${target} ${pairs})
endfunction()
