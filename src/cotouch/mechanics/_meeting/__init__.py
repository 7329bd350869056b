"""What skins meet: obstacles, other bodies, themselves, and tools that are bodies."""
