# roomgen_soname(<variable> <library>): the name under which programs load the shared library, such as
# libOSMesa.so.8 for /usr/lib/libOSMesa.so; its file name where that cannot be read.
include_guard()

function(roomgen_soname variable library)
  get_filename_component(name "${library}" NAME)
  if(CMAKE_OBJDUMP)
    execute_process(COMMAND "${CMAKE_OBJDUMP}" -p "${library}" OUTPUT_VARIABLE headers ERROR_QUIET)
    if(headers MATCHES "SONAME +([^ \n]+)")
      set(name "${CMAKE_MATCH_1}")
    endif()
  endif()
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()
