# Has the program write what shells, man and editors read, manual pages packed:
#   cmake -DPROGRAM=dda -DFOLDER=build/share -P shell_files.cmake
function(written file)
  get_filename_component(folder ${FOLDER}/${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

written(ddapath/deck.schema.json explain --json)
written(bash-completion/completions/dda completion bash)
written(zsh/site-functions/_dda completion zsh)
written(fish/vendor_completions.d/dda.fish completion fish)
foreach(page "man1/dda.1 man" "man5/dda-deck.5 man deck")
  separate_arguments(words UNIX_COMMAND "${page}")
  list(POP_FRONT words name)
  written(man/${name} ${words})
  execute_process(COMMAND gzip -9 --no-name --force ${FOLDER}/man/${name} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
