# Read by ctest after the tests of test_system have been discovered: each runs while nothing else does.
foreach(name IN LISTS test_system_TESTS)
  set_tests_properties("${name}" PROPERTIES RUN_SERIAL TRUE)
endforeach()
