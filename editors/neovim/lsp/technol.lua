-- Language server configuration for Neovim 0.11 or newer: `vim.lsp.enable("technol")` picks it up from the runtime path.
return {
  cmd = { "technol", "lsp" },
  filetypes = { "technol" },
  root_markers = { "technol.toml" },
  -- Language of the help: "en" or "cs".
  init_options = { language = "en" },
  settings = { technol = { language = "en" } },
}
