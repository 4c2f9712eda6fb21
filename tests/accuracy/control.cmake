exk_test(accuracy test_pi_closed_form SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_pi_closed_form.c
    NEEDS exk::control exk::random)
exk_test(accuracy test_ilc_convergence SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ilc_convergence.c
    NEEDS exk::control exk::plant)
exk_test(accuracy test_control_limits SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_control_limits.c
    NEEDS exk::control exk::plant)
