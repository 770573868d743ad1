# Lists the suites of a program of tests for CTest, each as one test that is
# called as they are behind its folder:
#
#   cmake -D PROGRAM=FILE -D FOLDER=NAME -D TIMEOUT=SECONDS -D LIST=FILE
#         -D LONG=REGEX -P list_suites.cmake
#
# Suites whose whole name LONG is have the label "long".
#
# A process takes longer to start than most tests take, and the tests of one
# suite share what they make once.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests
  OUTPUT_VARIABLE listed TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
# Suites stand at the beginning of a line, their tests behind two spaces.
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+[.]" suites "\n${listed}")
set(tests "")
foreach(suite ${suites})
  string(REGEX REPLACE "[\n.]" "" suite "${suite}")
  set(name "${FOLDER}/${suite}")
  string(APPEND tests
    "add_test(\"${name}\" \"${PROGRAM}\" \"--gtest_filter=${suite}.*\")\n"
    "set_tests_properties(\"${name}\" PROPERTIES TIMEOUT ${TIMEOUT}\n"
    "  ENVIRONMENT TAPFIT_NO_CACHE=1)\n")
  if(suite MATCHES "^(${LONG})$")
    string(APPEND tests "set_tests_properties(\"${name}\" PROPERTIES LABELS long)\n")
  endif()
endforeach()
file(WRITE "${LIST}" "${tests}")
