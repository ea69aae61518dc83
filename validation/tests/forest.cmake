# The text of glsl/forest on the CPU, against exact arithmetic.
gnomon_add_test(forest_cells_test LIBRARIES gnomon_forest_cases gnomon_forest_plain)
gnomon_add_device_test(forest_techniques_test TIMEOUT 600)
