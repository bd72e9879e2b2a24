// roomgen-decode: reads meshes for another program, over its standard input (decode/wire.h).

#include <unistd.h>

#include "confinement.h"
#include "decode/serve.h"

int main() { return roomgen::decode::serve(STDIN_FILENO, roomgen::decode::confine()); }
