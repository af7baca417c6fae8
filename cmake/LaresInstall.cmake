# `cmake --install` puts the binary into bin/ and what it reads at run time into share/lares/.
include(GNUInstallDirs)
if(TARGET lares)
  install(TARGETS lares RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(folder ontology ontology/priors recipes/skills recipes/library robots/models)
  file(GLOB shared CONFIGURE_DEPENDS ${folder}/*.ttl ${folder}/*.tsv)
  install(FILES ${shared} DESTINATION ${CMAKE_INSTALL_DATADIR}/lares/${folder})
endforeach()
