# What a program that links roomgen::render must find: static libraries pass their own needs on. OSMesa
# and OpenCV are loaded when a picture is drawn.
find_dependency(PNG)
find_dependency(JPEG)
