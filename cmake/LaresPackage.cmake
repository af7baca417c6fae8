# `cmake --build build/release --target package` makes lares_VERSION_ARCHITECTURE.deb (docs/install.md).
install(FILES packaging/lares.service DESTINATION lib/systemd/system COMPONENT debian)
find_program(GZIP gzip)
if(GZIP)
  set(changelog "${PROJECT_BINARY_DIR}/changelog.gz")
  execute_process(COMMAND "${GZIP}" -9nc "${PROJECT_SOURCE_DIR}/packaging/debian/changelog"
                  OUTPUT_FILE "${changelog}" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${changelog}" DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT debian)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lares)
set(CPACK_PACKAGE_VENDOR "The Lares authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "knowledge-based semantic mapping for service robots")
set(CPACK_PACKAGE_DESCRIPTION
"A server that is given action recipes (OWL), robot descriptions (SRDL) and
environments, and gives plans made for one robot or the reason why there is
none, tells where things are likely to be, and keeps every version of each map.
It needs no ROS and no network.")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Lares authors <lares@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS adduser)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "graphviz")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/packaging/debian/postinst;${PROJECT_SOURCE_DIR}/packaging/debian/prerm;${PROJECT_SOURCE_DIR}/packaging/debian/postrm")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
# One package of all components.
set(CPACK_DEB_COMPONENT_INSTALL OFF)
include(CPack)
