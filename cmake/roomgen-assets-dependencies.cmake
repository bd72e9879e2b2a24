# What a program that links roomgen::assets statically needs besides the core.
find_dependency(assimp)
find_dependency(LibZip)
find_dependency(SQLite3)
find_dependency(PNG)
find_dependency(JPEG)
find_dependency(Threads)
