# Run at installation: cmake -DLARES=… -DPREFIX=… -P write_pages.cmake
# What the binary itself writes, the manual and the completion, into the folders of `PREFIX`.
set(MAN "${PREFIX}/share/man/man1")
file(MAKE_DIRECTORY "${MAN}")
execute_process(COMMAND "${LARES}" man --all "${MAN}" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages "${MAN}/lares*.1")
find_program(GZIP gzip REQUIRED)
execute_process(COMMAND "${GZIP}" -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
foreach(place bash:bash-completion/completions/lares zsh:zsh/vendor-completions/_lares
              fish:fish/vendor_completions.d/lares.fish)
  string(REGEX MATCH "^([a-z]+):(.*)$" unused "${place}")
  set(shell "${CMAKE_MATCH_1}")
  set(file "${PREFIX}/share/${CMAKE_MATCH_2}")
  get_filename_component(folder "${file}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  execute_process(COMMAND "${LARES}" completion "${shell}" OUTPUT_FILE "${file}"
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
