# Alpha-tested and coloured casters: hit weights, texels, contributions and sums.
gnomon_add_test(transmittance_test LIBRARIES gnomon_frame gnomon_oracle)
gnomon_add_device_test(transmittance_device_test LIBRARIES spirv-cross-core TIMEOUT 120)
gnomon_test_shader(transmittance_device_test GNOMON_TRANSMITTANCE_SPIRV ${PROJECT_SOURCE_DIR}/validation/drop_in/core_transmittance_list.comp)
gnomon_test_shader(transmittance_device_test GNOMON_TRANSMITTANCE_SUM_SPIRV
  ${PROJECT_SOURCE_DIR}/validation/drop_in/core_transmittance_sum_list.comp)
gnomon_add_device_test(transmittance_scene_test RASTERISES TIMEOUT 300)
gnomon_test_shader(transmittance_scene_test GNOMON_TRANSMITTANCE_SCENE_SPIRV
  ${PROJECT_SOURCE_DIR}/validation/drop_in/core_transmittance_sum_list.comp)
target_compile_definitions(transmittance_scene_test PRIVATE GNOMON_SCENES_PROGRAM="$<TARGET_FILE:gnomon-scenes>"
  GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(transmittance_scene_test gnomon-scenes)
