# What a program that links roomgen::agent must find: static libraries pass their own needs on. A cpr that
# was installed along stands beside this folder; its targets name OpenSSL without finding it.
find_dependency(OpenSSL)
find_dependency(cpr HINTS "${CMAKE_CURRENT_LIST_DIR}/../cpr")
