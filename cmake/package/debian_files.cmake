# Makes of what was installed into the package what Debian's policy asks for; run by CPack before it packs.
set(usr "${CPACK_TEMPORARY_DIRECTORY}/usr")
set(documents "${usr}/share/doc/ddapath")

file(REMOVE "${documents}/LICENSE")
configure_file("${CPACK_DDA_COPYRIGHT}" "${documents}/copyright" COPYONLY)
string(TIMESTAMP DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${CPACK_DDA_CHANGELOG}" "${documents}/changelog" @ONLY)
file(RENAME "${documents}/CHANGELOG.md" "${documents}/NEWS.md")
execute_process(COMMAND gzip -9 --no-name "${documents}/changelog" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND gzip -9 --no-name "${documents}/NEWS.md" COMMAND_ERROR_IS_FATAL ANY)

file(MAKE_DIRECTORY "${usr}/share/zsh/vendor-completions")
file(RENAME "${usr}/share/zsh/site-functions/_dda" "${usr}/share/zsh/vendor-completions/_dda")
file(REMOVE_RECURSE "${usr}/share/zsh/site-functions")

# `import ddapath` in Debian's Python; the package finds the program from where the link leads.
file(MAKE_DIRECTORY "${usr}/lib/python3/dist-packages")
file(CREATE_LINK ../../../share/ddapath/python/ddapath "${usr}/lib/python3/dist-packages/ddapath" SYMBOLIC)
