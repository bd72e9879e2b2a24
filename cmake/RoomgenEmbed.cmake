# roomgen_embed(<target> BASE <dir> FILES …): compiles files into <target> as string literals, to be
# found at run time by their path relative to BASE (see base/resource.h).
include_guard()

function(roomgen_embed target)
  cmake_parse_arguments(arg "" "BASE" "FILES" ${ARGN})
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}_resources.cpp")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DBASE=${arg_BASE}" "-DFILES=${arg_FILES}" -P
            "${PROJECT_SOURCE_DIR}/cmake/embed.cmake"
    DEPENDS ${arg_FILES} "${PROJECT_SOURCE_DIR}/cmake/embed.cmake"
    COMMENT "Embedding data files"
    VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()
