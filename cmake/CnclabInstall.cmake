# `cmake --install build [--prefix DIR]` and the Debian package (`cpack --config build/CPackConfig.cmake`).
include(GNUInstallDirs)

# What is built is installed: no rebuild of tests for a package.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
install(TARGETS cnclab-server cnclab-station cnclab-instructor cnclab-tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.cnc")
install(FILES packaging/cnclab-server.service DESTINATION lib/systemd/system)

# Every key with its comment, as the server itself prints it.
set(configuration ${PROJECT_BINARY_DIR}/lab.toml)
add_custom_command(OUTPUT ${configuration}
  COMMAND cnclab-server --print-config > ${configuration}
  DEPENDS cnclab-server COMMENT "Writing lab.toml")
add_custom_target(cnclab-configuration ALL DEPENDS ${configuration})
install(FILES ${configuration} DESTINATION /etc/cnclab)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cnclab)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "cnclab <cnclab@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Training lab for the CNC 3300 milling control")
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS cups-client)  # [printer] queue
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/conffiles)
include(CPack)
