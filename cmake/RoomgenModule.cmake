# roomgen_add_module(<name> HEADERS … SOURCES … [PUBLIC …] [PRIVATE …] COMPONENT <component>)
#
# One module of a floor = one static library roomgen_<name>, alias roomgen::<name>. Always static
# and position independent, so that engines can fold the core into a shared library of their own.
# PUBLIC and PRIVATE are link dependencies; HEADERS, which users may include, are relative to
# include/roomgen/<name> and must be readable alone (target all_verify_interface_header_sets); other
# modules may include src/<name>/x.h as "<name>/x.h". The modules of the laboratory, lab_<part>, share
# include/roomgen/lab and lie in src/lab/<part>.
include_guard()

set_property(GLOBAL PROPERTY ROOMGEN_COMPONENTS "")

function(roomgen_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -Wnon-virtual-dtor)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # False alarms for "literal" + std::string (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
endfunction()

function(roomgen_add_module name)
  cmake_parse_arguments(arg "" "COMPONENT" "HEADERS;SOURCES;PUBLIC;PRIVATE" ${ARGN})
  string(REGEX REPLACE "^lab_.*" "lab" folder "${name}")
  list(TRANSFORM arg_HEADERS PREPEND "${PROJECT_SOURCE_DIR}/include/roomgen/${folder}/")

  set(target roomgen_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(roomgen::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include"
                                  FILES ${arg_HEADERS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  # What modules show each other, but not users: "module/header.h".
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src")
  # No fused multiply-add: placements must not depend on the instruction set.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  roomgen_warnings(${target})
  set_target_properties(
    ${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF
                         CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                         EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})

  if(ROOMGEN_INSTALL)
    install(TARGETS ${target} EXPORT roomgen-${arg_COMPONENT}
            ARCHIVE COMPONENT ${arg_COMPONENT} FILE_SET HEADERS COMPONENT ${arg_COMPONENT})
  endif()
  set_property(GLOBAL APPEND PROPERTY ROOMGEN_MODULES_${arg_COMPONENT} ${target})
endfunction()

# roomgen_finish_component(<component> [HEADERS …]): the target roomgen::<component> that users link, and
# its export set. HEADERS, relative to include/roomgen, belong to no module.
function(roomgen_finish_component component)
  cmake_parse_arguments(arg "" "" "HEADERS" ${ARGN})
  list(TRANSFORM arg_HEADERS PREPEND "${PROJECT_SOURCE_DIR}/include/roomgen/")
  get_property(modules GLOBAL PROPERTY ROOMGEN_MODULES_${component})
  if(NOT TARGET roomgen_${component})
    add_library(roomgen_${component} INTERFACE)
    add_library(roomgen::${component} ALIAS roomgen_${component})
    target_link_libraries(roomgen_${component} INTERFACE ${modules})
    target_sources(roomgen_${component} INTERFACE FILE_SET HEADERS
                   BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${arg_HEADERS})
    set_target_properties(roomgen_${component} PROPERTIES EXPORT_NAME ${component}
                                                          VERIFY_INTERFACE_HEADER_SETS ON)
    if(ROOMGEN_INSTALL)
      install(TARGETS roomgen_${component} EXPORT roomgen-${component}
              FILE_SET HEADERS COMPONENT ${component})
    endif()
  endif()
  if(ROOMGEN_INSTALL)
    install(EXPORT roomgen-${component} NAMESPACE roomgen:: FILE roomgen-${component}.cmake
            DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/roomgen)
  endif()
endfunction()
