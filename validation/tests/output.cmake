# What the program writes: files, EXR and PNG, pictures, records, tables.
foreach(test output_file_test output_exr_test output_picture_test output_record_test output_progress_test)
  gnomon_add_test(${test} LIBRARIES gnomon_output TIMEOUT 60)
endforeach()
