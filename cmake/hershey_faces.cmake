# Sets RESULT to a source made from TEMPLATE, in which @NAME@ stands for the Hershey font NAME.jhf. The fonts belong to
# Debian's package hershey-fonts-data and are not kept in this repository.
function(kfast_hershey_faces RESULT TEMPLATE)
    find_path(KFAST_HERSHEY_FONTS futural.jhf PATHS /usr/share/hershey-fonts NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH
        DOC "The folder of hershey-fonts-data")
    if(NOT KFAST_HERSHEY_FONTS)
        message(FATAL_ERROR "The Hershey fonts are missing: install hershey-fonts-data (scripts/install does), or set "
            "KFAST_HERSHEY_FONTS to the folder of futural.jhf")
    endif()
    file(READ ${TEMPLATE} TEXT)
    string(REGEX MATCHALL "@[a-z]+@" MARKS "${TEXT}")
    foreach(MARK ${MARKS})
        string(REPLACE "@" "" FACE ${MARK})
        file(READ ${KFAST_HERSHEY_FONTS}/${FACE}.jhf ${FACE})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${KFAST_HERSHEY_FONTS}/${FACE}.jhf)
    endforeach()
    get_filename_component(SOURCE ${TEMPLATE} NAME_WLE)
    configure_file(${TEMPLATE} ${SOURCE} @ONLY)
    set(${RESULT} ${CMAKE_CURRENT_BINARY_DIR}/${SOURCE} PARENT_SCOPE)
endfunction()
