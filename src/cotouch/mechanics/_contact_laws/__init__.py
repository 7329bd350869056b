"""Contact laws: pressure and energy by depth, one file for each."""
