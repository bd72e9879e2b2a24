# What a program that links roomgen::render must find: static libraries pass their own needs on.
find_dependency(OSMesa)
find_dependency(OpenCVImgproc)
find_dependency(PNG)
find_dependency(JPEG)
