# cpr, the HTTP library of the module agent (third_party/README.md). Where there is none, ROOMGEN_AGENT goes
# off: everything but the language models over HTTP works without.
option(ROOMGEN_FETCH_CPR "Download cpr's release when the system has none" OFF)

# scripts/cpr.sh installs there.
set(ROOMGEN_CPR_PREFIX "${PROJECT_SOURCE_DIR}/build/third_party/cpr")

# cpr's version file accepts only its own version, so the comparison is ours; its targets name OpenSSL
# without finding it.
find_package(OpenSSL QUIET)
find_package(cpr QUIET HINTS "${ROOMGEN_CPR_PREFIX}")
if(cpr_FOUND AND cpr_VERSION VERSION_LESS 1.10)
  message(STATUS "roomgen: cpr ${cpr_VERSION} is too old, 1.10 is needed")
  set(cpr_FOUND FALSE)
endif()

if(NOT cpr_FOUND AND ROOMGEN_FETCH_CPR)
  include(FetchContent)
  FetchContent_Declare(
    cpr URL https://github.com/libcpr/cpr/archive/refs/tags/1.12.0.tar.gz
    URL_HASH SHA256=f64b501de66e163d6a278fbb6a95f395ee873b7a66c905dd785eae107266a709)
  block()
    set(BUILD_SHARED_LIBS OFF)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
    set(CPR_USE_SYSTEM_CURL ON CACHE BOOL "" FORCE)
    set(CPR_BUILD_TESTS OFF CACHE BOOL "" FORCE)
    FetchContent_MakeAvailable(cpr)
    # It turns warnings into errors, which a newer compiler would trip over.
    target_compile_options(cpr PRIVATE -Wno-error)
  endblock()
  set(cpr_FOUND TRUE)
endif()

if(NOT cpr_FOUND)
  message(STATUS "roomgen: no cpr found, so no language models over HTTP (agent); scripts/test installs "
                 "it, ROOMGEN_FETCH_CPR=ON downloads it (third_party/README.md)")
  set(ROOMGEN_AGENT OFF)
endif()
