# Lets the protocol's official Python client talk with ROOMGEN in the folder WORK. Says "SKIPPED:" when PYTHON (which
# scripts/test makes) or the package mcp is missing.
execute_process(COMMAND "${PYTHON}" -c "import mcp" RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
if(NOT missing EQUAL 0)
  message("SKIPPED: there is no Python with the package mcp; see tests/mcp/requirements.txt")
  return()
endif()
execute_process(COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/python_client.py" "${ROOMGEN}" "${WORK}"
                COMMAND_ERROR_IS_FATAL ANY)
