# Clipper 6 (Debian: libpolyclipping-dev), as the target Polyclipping::polyclipping. It brings no CMake file.
find_path(Polyclipping_INCLUDE_DIR polyclipping/clipper.hpp)
find_library(Polyclipping_LIBRARY polyclipping)
mark_as_advanced(Polyclipping_INCLUDE_DIR Polyclipping_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Polyclipping REQUIRED_VARS Polyclipping_LIBRARY Polyclipping_INCLUDE_DIR)

if(Polyclipping_FOUND AND NOT TARGET Polyclipping::polyclipping)
  add_library(Polyclipping::polyclipping UNKNOWN IMPORTED)
  set_target_properties(Polyclipping::polyclipping PROPERTIES
    IMPORTED_LOCATION "${Polyclipping_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Polyclipping_INCLUDE_DIR}")
endif()
