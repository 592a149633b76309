"""One robot in other descriptions: joint axes, tables of either convention, screws and products, all ways round."""
