# gnomon-viz on dumps of the device: files read back, pictures looked at, bad input. It draws into an Xvfb of the test's own.
if(GNOMON_VIZ)
  find_package(X11 REQUIRED)
  find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel IOImage IOXML)
  gnomon_add_test(viz_test LIBRARIES gnomon_display gnomon_output gnomon_scene nlohmann_json::nlohmann_json ${VTK_LIBRARIES} TIMEOUT 300)
  target_sources(viz_test PRIVATE viz_forest_test.cpp)
  target_compile_definitions(viz_test PRIVATE GNOMON_PROGRAM="$<TARGET_FILE:gnomon>" GNOMON_VIZ_PROGRAM="$<TARGET_FILE:gnomon-viz>"
    GNOMON_SCENES_DIR="${PROJECT_SOURCE_DIR}/scenes")
  add_dependencies(viz_test gnomon gnomon-viz)
endif()
