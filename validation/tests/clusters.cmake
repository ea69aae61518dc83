gnomon_add_test(cluster_key_test TIMEOUT 60)
gnomon_add_test(cluster_bounds_test TIMEOUT 60)
