# Of OpenCV only imgproc. The configuration that distributions package insists on all modules, a
# gigabyte of them. Its headers, as OpenCVImgproc::OpenCVImgproc, and OpenCVImgproc_SONAME, the name under
# which the library is loaded at run time.
include(RoomgenSoname)
find_path(OpenCVImgproc_INCLUDE_DIR opencv2/imgproc/imgproc_c.h PATH_SUFFIXES opencv4)
find_library(OpenCVImgproc_LIBRARY opencv_imgproc)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVImgproc REQUIRED_VARS OpenCVImgproc_LIBRARY
                                                              OpenCVImgproc_INCLUDE_DIR)
mark_as_advanced(OpenCVImgproc_INCLUDE_DIR OpenCVImgproc_LIBRARY)
if(OpenCVImgproc_FOUND)
  roomgen_soname(OpenCVImgproc_SONAME "${OpenCVImgproc_LIBRARY}")
  if(NOT TARGET OpenCVImgproc::OpenCVImgproc)
    add_library(OpenCVImgproc::OpenCVImgproc INTERFACE IMPORTED)
    target_include_directories(OpenCVImgproc::OpenCVImgproc SYSTEM
                               INTERFACE "${OpenCVImgproc_INCLUDE_DIR}")
  endif()
endif()
