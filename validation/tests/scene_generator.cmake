gnomon_add_test(scene_generator_test LIBRARIES gnomon_scene_generator TIMEOUT 60)
target_compile_definitions(scene_generator_test PRIVATE GNOMON_SCENES_FOLDER="${PROJECT_SOURCE_DIR}/scenes"
  GNOMON_SCENES_PROGRAM="$<TARGET_FILE:gnomon-scenes>")
add_dependencies(scene_generator_test gnomon-scenes)
