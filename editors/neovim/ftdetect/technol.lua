vim.filetype.add({ extension = { plc = "technol", inc = "technol" } })
