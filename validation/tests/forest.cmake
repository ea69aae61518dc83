# The text of glsl/forest on the CPU, against exact arithmetic.
gnomon_add_test(forest_cells_test LIBRARIES gnomon_forest_cases gnomon_forest_plain)
gnomon_add_device_test(forest_techniques_test TIMEOUT 600)
add_test(NAME forest_techniques_test.one_thread COMMAND forest_techniques_test --gtest_filter=ForestTechnique.NodesWithoutPlanesAreTheSameTrees)
set_tests_properties(forest_techniques_test.one_thread PROPERTIES TIMEOUT 300 LABELS device ENVIRONMENT "LP_NUM_THREADS=1;GNOMON_VALIDATE=1"
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
