# gnomon-study: its parts, and the program as a child process. GNU parallel runs a plan.
gnomon_add_test(study_distance_test LIBRARIES gnomon_study_data TIMEOUT 60)
gnomon_add_test(study_results_test LIBRARIES gnomon_study_data TIMEOUT 60)
gnomon_add_test(study_expand_test LIBRARIES gnomon_study TIMEOUT 60)
target_compile_definitions(study_expand_test PRIVATE GNOMON_ROOT="${PROJECT_SOURCE_DIR}")
find_program(GNOMON_PARALLEL parallel REQUIRED)
foreach(part sweep stop plan bad_input)
  gnomon_add_test(study_${part}_test LIBRARIES gnomon_study_data nlohmann_json::nlohmann_json TIMEOUT 300)
  target_compile_definitions(study_${part}_test PRIVATE GNOMON_PROGRAM="$<TARGET_FILE:gnomon-study>" GNOMON_SHADE_PROGRAM="$<TARGET_FILE:gnomon>"
    GNOMON_SCENES_DIR="${PROJECT_SOURCE_DIR}/scenes" GNOMON_PARALLEL="${GNOMON_PARALLEL}")
  add_dependencies(study_${part}_test gnomon-study gnomon)
endforeach()

# Every technique and precision of the registry, from an empty folder, with the validation layer on.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/study_tiny)
add_test(NAME study_tiny COMMAND sh -c "rm -rf '${folder}' && exec '$<TARGET_FILE:gnomon-study>' short --tiny --results '${folder}/results.jsonl'"
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
set_tests_properties(study_tiny PROPERTIES TIMEOUT 300 LABELS device ENVIRONMENT "GNOMON_VALIDATE=1")
