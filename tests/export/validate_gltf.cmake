# Lets WRITER (a command whose last argument will be OUTPUT) write GLB files into the folder OUTPUT and has
# npm's gltf-validator judge them. Says "SKIPPED:" when node or the package is missing (scripts/test installs
# it into MODULES).
find_program(node NAMES node nodejs)
if(NOT node)
  message("SKIPPED: node is not installed")
  return()
endif()
if(NOT EXISTS "${MODULES}/gltf-validator")
  message("SKIPPED: ${MODULES} has no gltf-validator; npm install --prefix build gltf-validator")
  return()
endif()
execute_process(COMMAND ${WRITER} "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files "${OUTPUT}/*.glb")
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env "NODE_PATH=${MODULES}" "${node}"
          "${CMAKE_CURRENT_LIST_DIR}/validate_gltf.js" ${files}
  COMMAND_ERROR_IS_FATAL ANY)
