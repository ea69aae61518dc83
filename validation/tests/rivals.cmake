gnomon_add_device_test(ray_query_test LIBRARIES gnomon_camera_view)
gnomon_add_device_test(light_grid_test)
gnomon_add_test(study_embree_test LIBRARIES gnomon_oracle gnomon_output TIMEOUT 120)
target_sources(study_embree_test PRIVATE ../study/embree_peer.cpp ../study/peers.cpp)
