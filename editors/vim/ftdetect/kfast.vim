autocmd BufRead,BufNewFile *.kfast setfiletype kfast
