-- Debugging with nvim-dap: call require("technol_dap") after nvim-dap is loaded.
local found, dap = pcall(require, "dap")
if not found then
  -- Neovim shows a Lua error as twenty lines of folders that were searched.
  vim.notify(
    "technol_dap: nvim-dap is not loaded, so TECHNOL programs can be edited but not debugged; "
      .. "install https://github.com/mfussenegger/nvim-dap and call require(\"technol_dap\") after it",
    vim.log.levels.WARN
  )
  return false
end

dap.adapters.technol = { type = "executable", command = "technol", args = { "dap" } }

--- The project of the current file: the nearest folder with a manifest, or the file itself.
local function project()
  local file = vim.api.nvim_buf_get_name(0)
  local manifest = vim.fs.find("technol.toml", { upward = true, path = file })[1]
  return manifest and vim.fs.dirname(manifest) or file
end

dap.configurations.technol = {
  { type = "technol", request = "launch", name = "Run on the embedded target", program = project, target = "embedded" },
  {
    type = "technol",
    request = "launch",
    name = "Run on the embedded target, stopped at first",
    program = project,
    target = "embedded",
    stopOnEntry = true,
  },
  {
    type = "technol",
    request = "attach",
    name = "Attach to a target",
    program = project,
    target = function()
      return vim.fn.input("Target (tcp:HOST:PORT or serial:DEVICE@BAUD): ", "tcp:127.0.0.1:5700")
    end,
  },
}

return true
