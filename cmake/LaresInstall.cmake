# `cmake --install` puts the binary into bin/ and what it reads at run time into share/lares/.
include(GNUInstallDirs)
if(TARGET lares)
  install(TARGETS lares RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ontology/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lares/ontology
        FILES_MATCHING PATTERN "*.ttl" PATTERN "*.tsv")
install(DIRECTORY recipes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lares/recipes
        FILES_MATCHING PATTERN "*.ttl")
install(DIRECTORY robots/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lares/robots
        FILES_MATCHING PATTERN "*.ttl")
