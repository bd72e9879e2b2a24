# Lets the protocol's official TypeScript client talk with ROOMGEN in the folder WORK. Says "SKIPPED:" when node or the
# package is missing (scripts/test installs it into MODULES).
find_program(node NAMES node nodejs)
if(NOT node)
  message("SKIPPED: node is not installed")
  return()
endif()
if(NOT EXISTS "${MODULES}/@modelcontextprotocol/sdk")
  message("SKIPPED: ${MODULES} has no @modelcontextprotocol/sdk; npm install --prefix build @modelcontextprotocol/sdk")
  return()
endif()
# Modules are looked for beside the script.
file(MAKE_DIRECTORY "${WORK}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/typescript_client.mjs" DESTINATION "${WORK}")
file(CREATE_LINK "${MODULES}" "${WORK}/node_modules" SYMBOLIC)
execute_process(COMMAND "${node}" "${WORK}/typescript_client.mjs" "${ROOMGEN}" "${WORK}/rooms"
                COMMAND_ERROR_IS_FATAL ANY)
