# glsl/ as a user meets it: shaders that include a copy of it, its headers held against its code, its samples.
find_program(GNOMON_GLSLANG glslangValidator REQUIRED)
find_program(GNOMON_SPIRV_VAL spirv-val REQUIRED)
gnomon_add_test(drop_in_test TIMEOUT 300)
gnomon_add_test(contract_test TIMEOUT 180)
target_sources(contract_test PRIVATE ../support/contract.cpp ../support/glsl_source.cpp)
foreach(test drop_in_test contract_test)
  target_compile_definitions(${test} PRIVATE GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}" GNOMON_GLSLANG="${GNOMON_GLSLANG}"
    GNOMON_SPIRV_VAL="${GNOMON_SPIRV_VAL}")
endforeach()
gnomon_add_test(sample_test LIBRARIES gnomon_scene TIMEOUT 180)
