# What `cmake --install` and CPack put where.
include(GNUInstallDirs)
install(TARGETS lodestone-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(LODESTONE_GUI)
  install(TARGETS lodestone RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/installer/lodestone.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${PROJECT_SOURCE_DIR}/installer/lodestone-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/sample ${PROJECT_SOURCE_DIR}/resources/schemas
        DESTINATION ${CMAKE_INSTALL_DATADIR}/lodestone)
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PACKAGE_CONTACT "Lodestone maintainers <maintainers@lodestone.invalid>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
