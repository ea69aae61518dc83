# gnomon_embed_shaders(TARGET): makes the static library TARGET: compiles every example of glsl/ twice (plain, and NAME.counters with
# GNO_COUNTERS=1), checks it with spirv-val, and holds all of it as kEmbeddedShaders (host_min/vulkan/shader.cpp). Nested includes are tracked by
# dependency files.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(gnomon_embed_shaders target)
  set(root ${PROJECT_SOURCE_DIR}/glsl)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${root} ${root}/*/examples/*.comp ${root}/*/examples/*.vert ${root}/*/examples/*.frag
    ${root}/*/examples/*.geom)
  list(SORT sources)
  set(assembly "    .section .rodata\n")
  set(table "")
  set(externs "")
  set(outputs "")
  set(index 0)
  foreach(source IN LISTS sources)
    foreach(counters 0 1)
      set(name ${source})
      if(counters)
        set(name ${source}.counters)
      endif()
      set(output ${CMAKE_CURRENT_BINARY_DIR}/spirv/${name}.spv)
      get_filename_component(folder ${output} DIRECTORY)
      file(MAKE_DIRECTORY ${folder})
      add_custom_command(OUTPUT ${output}
        COMMAND ${GLSLANG} -V --target-env vulkan1.2 --quiet -DGNO_COUNTERS=${counters} --depfile ${output}.d -o ${output} ${root}/${source}
        COMMAND ${SPIRV_VAL} --target-env vulkan1.2 ${output}
        DEPENDS ${root}/${source} DEPFILE ${output}.d COMMENT "glsl/${name}" VERBATIM)
      list(APPEND outputs ${output})
      string(APPEND assembly
        "    .balign 4\n    .globl gnomon_spirv_${index}, gnomon_spirv_${index}_end\n"
        "gnomon_spirv_${index}:\n    .incbin \"${output}\"\ngnomon_spirv_${index}_end:\n")
      string(APPEND externs "extern const uint32_t gnomon_spirv_${index}[], gnomon_spirv_${index}_end[];\n")
      string(APPEND table "    {\"${name}\", gnomon_spirv_${index}, gnomon_spirv_${index}_end},\n")
      math(EXPR index "${index} + 1")
    endforeach()
  endforeach()
  string(APPEND assembly "    .section .note.GNU-stack,\"\",%progbits\n")
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/shaders.S CONTENT "${assembly}" @ONLY)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/shader_table.cpp CONTENT
"#include <cstddef>
#include <cstdint>
extern \"C\" {
${externs}}
namespace gno::host {
struct EmbeddedShader { const char* name; const uint32_t* first; const uint32_t* last; };
extern const EmbeddedShader kEmbeddedShaders[];
extern const size_t kEmbeddedShaderCount;
const EmbeddedShader kEmbeddedShaders[] = {
${table}};
const size_t kEmbeddedShaderCount = ${index};
}
" @ONLY)
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/shaders.S PROPERTIES OBJECT_DEPENDS "${outputs}")
  add_library(${target} STATIC ${CMAKE_CURRENT_BINARY_DIR}/shaders.S ${CMAKE_CURRENT_BINARY_DIR}/shader_table.cpp)
endfunction()
