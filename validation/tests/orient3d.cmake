gnomon_add_test(orient3d_test)

# The same text has to be GLSL 450 that makes valid SPIR-V, with and without the filter.
find_program(GNOMON_GLSLANG glslangValidator REQUIRED)
find_program(GNOMON_SPIRV_VAL spirv-val REQUIRED)
foreach(filter 0 1)
  set(spirv ${CMAKE_CURRENT_BINARY_DIR}/orient3d_filter${filter}.spv)
  add_custom_command(OUTPUT ${spirv}
    COMMAND ${GNOMON_GLSLANG} -V --target-env vulkan1.2 --quiet -DGNO_ORIENT3D_FILTER=${filter} --depfile ${spirv}.d -o ${spirv}
            ${PROJECT_SOURCE_DIR}/glsl/core/examples/orient3d.comp
    COMMAND ${GNOMON_SPIRV_VAL} --target-env vulkan1.2 ${spirv}
    DEPENDS ${PROJECT_SOURCE_DIR}/glsl/core/examples/orient3d.comp DEPFILE ${spirv}.d VERBATIM)
  target_sources(orient3d_test PRIVATE ${spirv})
endforeach()
