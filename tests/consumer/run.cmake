# Installs roomgen into a scratch prefix, then configures, builds and runs the consumer against it. The
# example of the README is its main program, taken from the README itself so that it stays true.
set(prefix "${WORK}/prefix")
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/source")

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command} failed:\n${out}")
  endif()
endfunction()

file(READ "${SOURCE}/README.md" readme)
string(REGEX MATCH "```cpp\n([^`]*)```" _ "${readme}")
if(NOT CMAKE_MATCH_1)
  message(FATAL_ERROR "README.md has no C++ example")
endif()
file(WRITE "${WORK}/source/main.cpp" "#include <cstdio>\n${CMAKE_MATCH_1}")
file(COPY "${SOURCE}/tests/consumer/CMakeLists.txt" "${SOURCE}/tests/consumer/core.cpp"
     "${SOURCE}/tests/consumer/agent.cpp" "${SOURCE}/tests/consumer/lab.cpp" DESTINATION "${WORK}/source")

run(${CMAKE_COMMAND} --install "${BINARY}" --prefix "${prefix}")
run(${CMAKE_COMMAND} -S "${WORK}/source" -B "${WORK}/build" -G Ninja "-DCMAKE_PREFIX_PATH=${prefix}"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/core_consumer")
run("${WORK}/build/consumer")
if(AGENT)
  run("${WORK}/build/agent_consumer")
endif()
if(LAB)
  run("${WORK}/build/lab_consumer")
endif()
