vim.bo.commentstring = "; %s"
vim.bo.comments = ":;"
-- Letters, digits, _ ? @ make a name.
vim.bo.iskeyword = "@,48-57,_,?,@-@"

-- Neovim before 0.11 has no vim.lsp.enable: the server is started with the file.
if vim.fn.has("nvim-0.11") == 0 and vim.lsp.start then
  local manifest = vim.fs.find("technol.toml", { upward = true, path = vim.api.nvim_buf_get_name(0) })[1]
  vim.lsp.start({
    name = "technol",
    cmd = { "technol", "lsp" },
    root_dir = manifest and vim.fs.dirname(manifest) or nil,
    init_options = { language = "en" },
  })
end
