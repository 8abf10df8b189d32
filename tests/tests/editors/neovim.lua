-- Runs in Neovim: the files of editors/neovim, the language server and the debug adapter, as a user has them.
-- TECHNOL_EDITOR: those files; TECHNOL_LATHE: a project; TECHNOL_NVIM_DAP: nvim-dap, or nothing.

local editor, lathe = os.getenv("TECHNOL_EDITOR"), os.getenv("TECHNOL_LATHE")
local PATIENCE = 60000

local function wait(what, condition)
  if not vim.wait(PATIENCE, condition, 50) then
    error("this did not happen: " .. what, 2)
  end
end

local function equal(what, actual, expected)
  if not vim.deep_equal(actual, expected) then
    error(what .. ": " .. vim.inspect(actual) .. " is not " .. vim.inspect(expected), 2)
  end
end

local function line_of(text)
  for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
    if line:find(text, 1, true) then
      return number, line:find(text, 1, true)
    end
  end
  error("there is no line with " .. text)
end

--- The result of the only server that answers, for the place of `text` (and `offset` bytes).
local function ask(method, text, offset)
  local line, column = line_of(text)
  vim.api.nvim_win_set_cursor(0, { line, column - 1 + offset })
  local place = vim.lsp.util.make_position_params(0, "utf-16")
  local answers = vim.lsp.buf_request_sync(0, method, place, PATIENCE) or {}
  local _, answer = next(answers)
  assert(answer and answer.result, method .. " got no answer: " .. vim.inspect(answers))
  return answer.result
end

local tests = {}

function tests.a_file_is_recognised_and_its_server_starts()
  equal("file type", vim.bo.filetype, "technol")
  equal("comments", vim.bo.commentstring, "; %s")
  local function client()
    return vim.lsp.get_clients({ bufnr = 0, name = "technol" })[1]
  end
  wait("the server is ready", function()
    return client() ~= nil and client().initialized
  end)
  equal("root", vim.uv.fs_realpath(client().config.root_dir), vim.uv.fs_realpath(lathe))
end

function tests.the_configuration_of_newer_versions_names_the_same_server()
  local config = dofile(editor .. "/lsp/technol.lua")
  equal("command", config.cmd, { "technol", "lsp" })
  equal("file types", config.filetypes, { "technol" })
  equal("root", config.root_markers, { "technol.toml" })
end

function tests.mistakes_are_shown_while_typing_and_go_away()
  local line = line_of("MODULE_MAIN")
  vim.api.nvim_buf_set_lines(0, line, line, false, { "        LDR  NOBODY" })
  local function found()
    for _, it in ipairs(vim.diagnostic.get(0)) do
      if it.message:find("NOBODY", 1, true) and it.lnum == line then
        return true
      end
    end
    return false
  end
  wait("the unknown name is reported", found)
  vim.api.nvim_buf_set_lines(0, line, line + 1, false, {})
  wait("it is reported no more", function()
    return #vim.diagnostic.get(0) == 0
  end)
end

function tests.help_is_shown()
  local hover = ask("textDocument/hover", "TEX0 -,T_STANDSTILL", 1)
  assert(hover.contents.value:find("TEX0", 1, true), vim.inspect(hover))
end

function tests.gd_goes_to_a_declaration_in_another_file()
  local line, column = line_of("LDR  SP_STAND")
  vim.api.nvim_win_set_cursor(0, { line, column + 5 })
  vim.lsp.buf.definition()
  wait("main.plc is open", function()
    return vim.api.nvim_buf_get_name(0):find("main.plc", 1, true) ~= nil
  end)
  assert(vim.api.nvim_get_current_line():find("SP_STAND", 1, true), vim.api.nvim_get_current_line())
  vim.cmd.edit(lathe .. "/spindle.plc")
end

function tests.names_are_completed()
  local result = ask("textDocument/completion", "LDR  SP_STAND", 8)
  local labels = vim.tbl_map(function(item)
    return item.label
  end, result.items or result)
  assert(vim.tbl_contains(labels, "SP_STAND"), vim.inspect(labels))
end

function tests.without_nvim_dap_it_says_what_is_missing()
  local told
  local notify = vim.notify
  vim.notify = function(message, level)
    told = { message, level }
  end
  local ok, loaded = pcall(require, "technol_dap")
  vim.notify = notify
  package.loaded.technol_dap = nil
  equal("loaded", { ok, loaded }, { true, false })
  equal("level", told[2], vim.log.levels.WARN)
  assert(told[1]:find("nvim-dap is not loaded", 1, true), told[1])
end

function tests.what_nvim_dap_is_given_starts_a_session()
  local dap = { adapters = {}, configurations = {} }
  package.loaded.dap = dap
  equal("loaded", require("technol_dap"), true)
  package.loaded.dap, package.loaded.technol_dap = nil, nil
  local adapter, configuration = dap.adapters.technol, dap.configurations.technol[2]
  local launch = {}
  for key, value in pairs(configuration) do
    launch[key] = type(value) == "function" and value() or value
  end
  equal("program", vim.uv.fs_realpath(launch.program), vim.uv.fs_realpath(lathe))

  local heard, ended = "", nil
  local job = vim.fn.jobstart(vim.list_extend({ adapter.command }, adapter.args), {
    on_stdout = function(_, data)
      heard = heard .. table.concat(data, "\n")
    end,
    on_exit = function(_, code)
      ended = code
    end,
  })
  assert(job > 0, "the adapter does not start")
  local function say(seq, command, arguments)
    local body = vim.json.encode({ seq = seq, type = "request", command = command, arguments = arguments })
    vim.fn.chansend(job, ("Content-Length: %d\r\n\r\n%s"):format(#body, body))
  end
  say(1, "initialize", { adapterID = "technol" })
  say(2, "launch", launch)
  wait("the adapter is ready for break-points", function()
    return heard:find('"event":"initialized"', 1, true) ~= nil
  end)
  say(3, "configurationDone", vim.empty_dict())
  wait("it stops at the entry", function()
    return heard:find('"reason":"entry"', 1, true) ~= nil
  end)
  say(4, "disconnect", vim.empty_dict())
  wait("it ends", function()
    return ended ~= nil
  end)
  equal("exit code", ended, 0)
end

function tests.nvim_dap_stops_at_a_break_point()
  local folder = os.getenv("TECHNOL_NVIM_DAP")
  if folder == nil or folder == "" then
    return "TECHNOL_NVIM_DAP does not name a folder with nvim-dap"
  end
  vim.opt.runtimepath:append(folder)
  equal("loaded", require("technol_dap"), true)
  local dap = require("dap")
  local line = line_of("LOD  SP_STARTS")
  vim.api.nvim_win_set_cursor(0, { line, 0 })
  dap.set_breakpoint()
  local configuration = vim.deepcopy(dap.configurations.technol[1])
  dap.run(configuration)
  wait("it stops", function()
    local session = dap.session()
    return session ~= nil and session.current_frame ~= nil
  end)
  equal("line", dap.session().current_frame.line, line)
  equal("mechanism", dap.session().current_frame.name, "SP_CONTROL")
  dap.step_over()
  wait("it steps", function()
    local session = dap.session()
    return session.current_frame ~= nil and session.current_frame.line == line + 1
  end)
  dap.terminate()
  wait("it ends", function()
    return dap.session() == nil
  end)
end

local ORDER = {
  "a_file_is_recognised_and_its_server_starts",
  "the_configuration_of_newer_versions_names_the_same_server",
  "mistakes_are_shown_while_typing_and_go_away",
  "help_is_shown",
  "gd_goes_to_a_declaration_in_another_file",
  "names_are_completed",
  "without_nvim_dap_it_says_what_is_missing",
  "what_nvim_dap_is_given_starts_a_session",
  "nvim_dap_stops_at_a_break_point",
}

vim.opt.swapfile = false
vim.opt.hidden = true
vim.opt.runtimepath:append(editor)
vim.cmd("filetype plugin on")
if vim.lsp.enable then
  vim.lsp.enable("technol")
end
vim.cmd.edit(lathe .. "/spindle.plc")

local failed = false
for _, name in ipairs(ORDER) do
  local ok, said = xpcall(tests[name], debug.traceback)
  local result = ok and (said and "SKIPPED: " .. said or "ok") or "FAILED: " .. tostring(said)
  failed = failed or not ok
  io.stdout:write(name, " ", result, "\n")
end
vim.cmd(failed and "cquit 1" or "qall!")
