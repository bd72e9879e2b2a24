# Of OpenCV only core and imgproc. The configuration that distributions package insists on all
# modules, a gigabyte of them. Defines OpenCVImgproc::OpenCVImgproc.
find_path(OpenCVImgproc_INCLUDE_DIR opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
find_library(OpenCVImgproc_CORE_LIBRARY opencv_core)
find_library(OpenCVImgproc_IMGPROC_LIBRARY opencv_imgproc)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  OpenCVImgproc REQUIRED_VARS OpenCVImgproc_IMGPROC_LIBRARY OpenCVImgproc_CORE_LIBRARY
                              OpenCVImgproc_INCLUDE_DIR)
mark_as_advanced(OpenCVImgproc_INCLUDE_DIR OpenCVImgproc_CORE_LIBRARY
                 OpenCVImgproc_IMGPROC_LIBRARY)
if(OpenCVImgproc_FOUND AND NOT TARGET OpenCVImgproc::OpenCVImgproc)
  add_library(OpenCVImgproc::OpenCVImgproc UNKNOWN IMPORTED)
  set_target_properties(
    OpenCVImgproc::OpenCVImgproc
    PROPERTIES IMPORTED_LOCATION "${OpenCVImgproc_IMGPROC_LIBRARY}"
               INTERFACE_LINK_LIBRARIES "${OpenCVImgproc_CORE_LIBRARY}"
               INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenCVImgproc_INCLUDE_DIR}"
               INTERFACE_INCLUDE_DIRECTORIES "${OpenCVImgproc_INCLUDE_DIR}")
endif()
