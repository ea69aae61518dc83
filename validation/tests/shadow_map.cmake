# Shadow maps: projections on the CPU, pictures on the device.
gnomon_add_test(shadow_map_view_test LIBRARIES gnomon_techniques TIMEOUT 60)
gnomon_add_device_test(shadow_map_test RASTERISES)
