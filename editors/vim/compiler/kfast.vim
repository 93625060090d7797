if exists('current_compiler')
    finish
endif
let current_compiler = 'kfast'

" The line of the scene and the marks below it are left out; the remedy joins the message. Below: a file that cannot be
" read, and what shells say when there is no kfast.
CompilerSet makeprg=kfast\ check\ %:S
CompilerSet errorformat=
    \%E%f:%l:%c:\ error:\ %m,
    \%W%f:%l:%c:\ warning:\ %m,
    \%Z\ %#=\ help:\ %m,
    \%-C\ %#%*\\d\ \|%.%#,
    \%-C\ %#\|%.%#,
    \%-Gkfast:\ %.%#:\ %*\\d\ error%.%#,
    \%Ekfast:\ %f:\ %m,
    \%+E%.%#kfast:%.%#not\ found%.%#,
    \%+E%.%#not\ found:\ kfast%.%#,
    \%-G%.%#
