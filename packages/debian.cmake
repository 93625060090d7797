# The packages kfast and libkfast-dev, by cpack: scripts/package.
find_program(KFAST_DPKG dpkg)
if(NOT KFAST_DPKG)
    return()
endif()

# One and the same commit makes one and the same package.
execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE KFAST_CHANGED OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    set(KFAST_CHANGED $ENV{SOURCE_DATE_EPOCH})
elseif(NOT KFAST_CHANGED)
    set(KFAST_CHANGED 0)
endif()
execute_process(COMMAND date --utc --rfc-email --date=@${KFAST_CHANGED}
    OUTPUT_VARIABLE KFAST_CHANGED_DATE OUTPUT_STRIP_TRAILING_WHITESPACE)

string(JSON KFAST_AUTHOR GET ${KFAST_PROJECT} author)
string(JSON KFAST_MAIL GET ${KFAST_PROJECT} mail)
string(JSON KFAST_URL GET ${KFAST_PROJECT} url)
# A maintainer without an address is no maintainer to Debian's tools. What ends in .invalid reaches nobody.
if(NOT KFAST_MAIL)
    set(KFAST_MAIL kfast@kfast.invalid)
endif()
set(KFAST_MAINTAINER "${KFAST_AUTHOR} <${KFAST_MAIL}>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kfast)
set(CPACK_PACKAGE_VENDOR ${KFAST_AUTHOR})
set(CPACK_PACKAGE_CONTACT ${KFAST_MAINTAINER})
if(KFAST_URL)
    set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${KFAST_URL})
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL kfast)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_KFAST_PACKAGE_NAME kfast)
set(CPACK_DEBIAN_KFAST_PACKAGE_SECTION graphics)
if(CMAKE_CROSSCOMPILING) # dpkg-shlibdeps knows the libraries of this computer alone: scripts/package says them
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${KFAST_DEBIAN_ARCHITECTURE})
else()
    set(CPACK_DEBIAN_KFAST_PACKAGE_SHLIBDEPS ON)
endif()
set(CPACK_DEBIAN_KFAST_PACKAGE_RECOMMENDS udev)
set(CPACK_DEBIAN_KFAST_PACKAGE_SUGGESTS ffmpeg)
set(CPACK_DEBIAN_KFAST_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/postinst)
set(CPACK_COMPONENT_KFAST_DESCRIPTION "vector key-frame animation for displays on microcontrollers
The command kfast draws, previews, measures and compiles animations that are
written as texts or come from SVG, Lottie or Synfig, and puts them on boards
with small displays. The firmware for the Raspberry Pi Pico is included.")

# kfast_indented(<variable> <file>): its text as a field of Debian's files has it.
function(kfast_indented RESULT FILE)
    file(READ ${FILE} TEXT)
    string(STRIP "${TEXT}" TEXT)
    string(REPLACE "\n\n" "\n.\n" TEXT "${TEXT}")
    string(REPLACE "\n" "\n " TEXT "${TEXT}")
    set(${RESULT} " ${TEXT}" PARENT_SCOPE)
endfunction()
kfast_indented(LICENCE_TEXT ${PROJECT_SOURCE_DIR}/LICENSE)
kfast_indented(NOTICE_TEXT ${PROJECT_SOURCE_DIR}/NOTICE)

# kfast_debian_texts(<package> <component>): the changelog and the copyright that Debian wants.
function(kfast_debian_texts PACKAGE COMPONENT)
    set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/debian/${PACKAGE})
    configure_file(debian/changelog.in ${FOLDER}/changelog @ONLY)
    execute_process(COMMAND gzip -9nf ${FOLDER}/changelog)
    configure_file(debian/copyright.in ${FOLDER}/copyright @ONLY)
    install(FILES ${FOLDER}/changelog.gz ${FOLDER}/copyright
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${PACKAGE} COMPONENT ${COMPONENT} EXCLUDE_FROM_ALL)
endfunction()
kfast_debian_texts(kfast kfast)

if(KFAST_LIBRARY)
    list(APPEND CPACK_COMPONENTS_ALL development)
    kfast_debian_texts(libkfast-dev development)
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkfast-dev)
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS kfast)
    set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "player for vector animations of kfast, to link with
A player for compiled scenes of kfast, for C and C++, that hands out
rectangles of finished pixels. It has no heap and no floating point, so that
it plays on microcontrollers as well.")
endif()

include(CPack)
