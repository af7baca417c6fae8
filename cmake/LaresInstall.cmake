# `cmake --install` puts the binary into bin/, what it reads at run time into share/lares/, and the
# manual and completion, which the binary writes itself, where each is looked for.
include(GNUInstallDirs)
if(TARGET lares)
  install(TARGETS lares RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -DLARES=$<TARGET_FILE:lares>
    \"-DPREFIX=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\"
    -P \"${PROJECT_SOURCE_DIR}/packaging/write_pages.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
endif()
foreach(folder ontology ontology/priors recipes/skills recipes/library robots/models)
  file(GLOB shared CONFIGURE_DEPENDS ${folder}/*.ttl ${folder}/*.tsv)
  install(FILES ${shared} DESTINATION ${CMAKE_INSTALL_DATADIR}/lares/${folder})
endforeach()
file(GLOB documents CONFIGURE_DEPENDS docs/*.md docs/*.svg)
install(FILES ${documents} README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/schemas DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY demo DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        FILES_MATCHING PATTERN "*.ttl" PATTERN "*.yaml" PATTERN "*.pgm" PATTERN "README.md")
install(FILES packaging/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
