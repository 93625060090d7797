# Finds the Python 3 that has the Python Imaging Library: tests compare pictures with it.
function(kfast_python_has_pictures RESULT PYTHON)
    execute_process(COMMAND ${PYTHON} -c "import PIL.Image" RESULT_VARIABLE STATUS OUTPUT_QUIET ERROR_QUIET)
    if(NOT STATUS EQUAL 0)
        set(${RESULT} FALSE PARENT_SCOPE)
    endif()
endfunction()

find_program(KFAST_PYTHON python3 VALIDATOR kfast_python_has_pictures)
