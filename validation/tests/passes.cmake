# Pass lists against the compiled shaders, without a device; and their barriers under synchronization validation, a program a module. What these
# record is not run, so one width does.
add_library(gnomon_shader_access STATIC ${PROJECT_SOURCE_DIR}/validation/support/shader_access.cpp)
target_link_libraries(gnomon_shader_access PRIVATE gnomon_flags spirv-cross-core)
gnomon_add_test(pass_list_test LIBRARIES gnomon_frame gnomon_shaders gnomon_module_lists gnomon_shader_access TIMEOUT 60)

function(gnomon_add_barrier_test name)
  add_executable(${name} ${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE gnomon_flags gnomon_device_test)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 LABELS device ENVIRONMENT "LP_NATIVE_VECTOR_WIDTH=256;GNOMON_VALIDATE=1"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()
gnomon_add_barrier_test(pass_barriers_forest_test)
gnomon_add_barrier_test(pass_barriers_clusters_test)
gnomon_add_barrier_test(pass_barriers_rivals_test)
gnomon_add_barrier_test(pass_barriers_shadow_map_test)
gnomon_add_barrier_test(pass_barriers_top_test)
