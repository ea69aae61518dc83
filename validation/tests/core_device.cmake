# Queries of structures that are not there to ask.
gnomon_add_device_test(answers_test)

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
gnomon_add_device_test(sample_from_depth_test RASTERISES)
target_compile_definitions(sample_from_depth_test PRIVATE GNOMON_SCENES_DIR="${PROJECT_SOURCE_DIR}/scenes")

# The queries that look for what should not happen; what they count stands where others count nodes and stack entries.
gnomon_add_device_test(debug_test)
foreach(query STACK STACKLESS HYBRID)
  string(TOLOWER ${query} name)
  gnomon_test_shader(debug_test GNOMON_DEBUG_${query} ${PROJECT_SOURCE_DIR}/glsl/top/examples/query_${name}.comp
    -DGNO_DEBUG=1 -DGNO_DEBUG_LIMIT=1000u -DGNO_COUNTERS=1 "-DGNO_EXAMPLE_COUNTS=uvec4(gnoDebugFaults.endless, gnoDebugFaults.outside, 0u, 0u)")
endforeach()
gnomon_add_device_test(several_lights_test RASTERISES TIMEOUT 120)
target_compile_definitions(several_lights_test PRIVATE GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
foreach(pair "TREES top_query_hybrid" "FORESTS forest_trees" "LISTS rivals_light_grid_query" "HIERARCHIES rivals_light_bvh_query")
  separate_arguments(pair)
  list(GET pair 0 name)
  list(GET pair 1 shader)
  gnomon_test_shader(several_lights_test GNOMON_SEVERAL_${name} ${PROJECT_SOURCE_DIR}/validation/drop_in/${shader}.several_lights.comp)
endforeach()
