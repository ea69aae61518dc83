# The project's text about itself: length of lines, one version, links and tables of files.
find_program(GNOMON_GLSLANG glslangValidator REQUIRED)
find_program(GNOMON_SPIRV_VAL spirv-val REQUIRED)
foreach(test line_length_test version_test documents_test)
  gnomon_add_test(${test} TIMEOUT 60)
  target_compile_definitions(${test} PRIVATE GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}" GNOMON_GLSLANG="${GNOMON_GLSLANG}"
    GNOMON_SPIRV_VAL="${GNOMON_SPIRV_VAL}")
endforeach()
target_compile_definitions(version_test PRIVATE GNOMON_PROGRAM="$<TARGET_FILE:gnomon>")
add_dependencies(version_test gnomon)
if(GNOMON_VIZ)
  target_compile_definitions(version_test PRIVATE GNOMON_VIZ_PROGRAM="$<TARGET_FILE:gnomon-viz>")
  add_dependencies(version_test gnomon-viz)
endif()

# What travels: an installation and the projects that use it, and the smallest engine.
add_test(NAME install
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/install_test.sh ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/installed)
set_tests_properties(install PROPERTIES TIMEOUT 120)
set(HELLO_SPIRV ${PROJECT_BINARY_DIR}/host_min/spirv)
add_subdirectory(${PROJECT_SOURCE_DIR}/glsl/hello ${CMAKE_CURRENT_BINARY_DIR}/hello)
add_test(NAME hello COMMAND hello ${HELLO_SPIRV} ${CMAKE_CURRENT_BINARY_DIR}/hello.png)
set_tests_properties(hello PROPERTIES TIMEOUT 120 LABELS device FAIL_REGULAR_EXPRESSION "Validation (Error|Warning)|VUID-|SYNC-HAZARD"
  ENVIRONMENT "VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation;VK_LAYER_ENABLES=VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT")

# glsl/MODULES.md: its tables are the lists, and what it says to copy is enough.
add_library(gnomon_module_lists STATIC ${PROJECT_SOURCE_DIR}/validation/support/module_lists.cpp)
target_link_libraries(gnomon_module_lists PUBLIC gnomon_flags)
add_executable(gnomon-modules ${PROJECT_SOURCE_DIR}/validation/modules_page.cpp)
target_link_libraries(gnomon-modules PRIVATE gnomon_module_lists gnomon_output gnomon_vulkan)
target_compile_definitions(gnomon-modules PRIVATE GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_test(NAME modules_page COMMAND gnomon-modules ${PROJECT_SOURCE_DIR}/glsl/MODULES.md)
gnomon_add_test(copy_test LIBRARIES gnomon_module_lists gnomon_vulkan TIMEOUT 120)
target_compile_definitions(copy_test PRIVATE GNOMON_SOURCE_DIR="${PROJECT_SOURCE_DIR}" GNOMON_GLSLANG="${GNOMON_GLSLANG}"
  GNOMON_CXX="${CMAKE_CXX_COMPILER}")
