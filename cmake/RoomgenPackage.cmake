# cpack makes roomgen_<version>_<architecture>.deb and a tarball of the program and what it loads, without
# what only compilers need (scripts/package builds, packs and tries them).
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME roomgen)
set(CPACK_PACKAGE_VENDOR roomgen)
set(CPACK_PACKAGE_CONTACT "roomgen maintainers <roomgen@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)

set(CPACK_PACKAGE_FILE_NAME "roomgen-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_ARCHIVE_FILE_NAME "${CPACK_PACKAGE_FILE_NAME}")
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
# One folder holds all of the tarball, but not of the .deb.
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_BINARY_DIR}/CPackFolder.cmake")
file(WRITE "${CPACK_PROJECT_CONFIG_FILE}" "if(CPACK_GENERATOR STREQUAL TGZ)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The furniture that the program looks for; without it everything is made from words.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS sweethome3d-furniture)

# Libraries that the program opens by name are no dependencies that dpkg-shlibdeps could see.
set(packages "")
foreach(library IN LISTS LibEdit_LIBRARY OSMesa_LIBRARY OpenCVImgproc_LIBRARY)
  file(REAL_PATH "${library}" file)
  execute_process(COMMAND dpkg-query -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0 AND owner MATCHES "^([^:]+):")
    list(APPEND packages "${CMAKE_MATCH_1}")
  endif()
endforeach()
list(JOIN packages ", " CPACK_DEBIAN_PACKAGE_DEPENDS)

# Our own licence, and those of what is compiled in.
set(licences "${CMAKE_INSTALL_DATADIR}/doc/roomgen")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${licences}" RENAME copyright COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/data/language/wordnet-licence.txt" DESTINATION "${licences}"
        RENAME wordnet.txt COMPONENT program)
install(FILES "${ROOMGEN_CPR_PREFIX}/LICENSE" DESTINATION "${licences}" RENAME cpr.txt
        COMPONENT program OPTIONAL)
foreach(package libeigen3-dev nlohmann-json3-dev libcli11-dev)
  install(FILES "/usr/share/doc/${package}/copyright" DESTINATION "${licences}" RENAME ${package}.txt
          COMPONENT program OPTIONAL)
endforeach()
include(CPack)
