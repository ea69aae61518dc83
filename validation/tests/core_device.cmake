# Layouts in the compiled SPIR-V, and functions of core/ on the device against the same text compiled as C++.
find_program(GNOMON_GLSLANG glslangValidator REQUIRED)
find_program(GNOMON_SPIRV_VAL spirv-val REQUIRED)
gnomon_add_test(layout_test LIBRARIES gnomon_frame gnomon_shaders spirv-cross-core TIMEOUT 60)

# Shaders that these tests run themselves. The folder glsl/ is met under the name that drop_in/ includes it by.
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/mount)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/glsl ${CMAKE_CURRENT_BINARY_DIR}/mount/gnomon SYMBOLIC)
function(gnomon_test_shader target definition source)  # compiles source with the options behind it; its path is `definition` in the program `target`
  set(spirv ${CMAKE_CURRENT_BINARY_DIR}/${definition}.spv)
  add_custom_command(OUTPUT ${spirv}
    COMMAND ${GNOMON_GLSLANG} -V --target-env vulkan1.2 --quiet -I${CMAKE_CURRENT_BINARY_DIR}/mount ${ARGN} --depfile ${spirv}.d -o ${spirv}
      ${source}
    COMMAND ${GNOMON_SPIRV_VAL} --target-env vulkan1.2 ${spirv}
    DEPENDS ${source} DEPFILE ${spirv}.d VERBATIM)
  target_sources(${target} PRIVATE ${spirv})
  target_compile_definitions(${target} PRIVATE ${definition}="${spirv}")
endfunction()
gnomon_add_device_test(orient3d_device_test TIMEOUT 120)
gnomon_test_shader(orient3d_device_test GNOMON_ORIENT3D_UNFILTERED ${PROJECT_SOURCE_DIR}/glsl/core/examples/orient3d.comp -DGNO_ORIENT3D_FILTER=0)
gnomon_add_device_test(permutation_test TIMEOUT 120)
gnomon_test_shader(permutation_test GNOMON_PERMUTATION_SPIRV ${PROJECT_SOURCE_DIR}/validation/drop_in/core_permutation_list.comp)
gnomon_add_device_test(sample_device_test TIMEOUT 120)
gnomon_test_shader(sample_device_test GNOMON_SAMPLE_SPIRV ${PROJECT_SOURCE_DIR}/validation/drop_in/core_sample_list.comp)
